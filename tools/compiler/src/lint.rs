//! What a module must not do: resources that cannot be carried over, and more than its tier has.

use crate::compile::CompiledCombination;
use crate::layout::Type;
use crate::problem::Problem;
use crate::program::Program;
use crate::reflect::{Binding, Kind};
use crate::text::Text;
use crate::tier::Tier;

/// Everything wrong with a program's modules.
pub fn lint(program: &Program, combinations: &[CompiledCombination], text: &Text) -> Vec<Problem> {
    let mut problems = Vec::new();
    let stages = combinations.iter().flat_map(|one| one.stages.iter().map(|stage| (&one.combination, stage)));
    for (combination, stage) in stages {
        let tier = program.tier_of(combination);
        for binding in &stage.reflection.bindings {
            let found = resource(binding, text);
            problems.extend(found.map(|problem| problem.kernel(stage.label.clone())));
        }
        let excess = tier.excess(&stage.reflection);
        if !excess.is_empty() {
            let place = text.function(&stage.entry).map_or_else(|| program.place.clone(), |(place, _)| place);
            let way_out = match Tier::of(&stage.reflection) {
                Some(tier) => format!(
                    "use less, or say `#pragma tier {}`, of some variants with ` : KEYWORDS`, if devices below it never run it",
                    tier.name()
                ),
                None => "use less: no tier has that".to_owned(),
            };
            problems.push(
                Problem::new(format!("it is beyond the {} tier: {}", tier.name(), excess.join(", ")))
                    .at_place(Some(place))
                    .kernel(stage.label.clone())
                    .way_out(way_out),
            );
        }
    }
    problems.extend(group_size(program, combinations, text));
    problems
}

fn group_size(program: &Program, combinations: &[CompiledCombination], text: &Text) -> Option<Problem> {
    let sizes = |combination: &CompiledCombination| combination.stages[0].reflection.group_size;
    let first = sizes(combinations.first()?);
    let other = combinations.iter().find(|other| sizes(other) != first)?;
    let place = text.function(&program.entries[0].1).map(|(place, _)| place);
    Some(
        Problem::new(format!("its group size differs between variants ({first:?} and {:?})", sizes(other)))
            .at_place(place)
            .kernel(other.stages[0].label.clone())
            .way_out("give the variants one group size, or make two kernels of them"),
    )
}

fn resource(binding: &Binding, text: &Text) -> Option<Problem> {
    let declaration = text.resource(binding.name.trim_start_matches("counter.var."));
    let place = declaration.as_ref().map(|declaration| declaration.place.clone());
    let problem = if binding.name.starts_with("counter.var.") {
        Problem::new(format!(
            "{} has a hidden counter (Append, Consume or IncrementCounter), which is not supported",
            binding.name.trim_start_matches("counter.var.")
        ))
        .way_out("count with InterlockedAdd in a RWStructuredBuffer<uint> of your own")
    } else {
        match &binding.kind {
            Kind::Unsupported { what, way_out } => {
                Problem::new(format!("{} is {what}, which is not supported", binding.name)).way_out(*way_out)
            }
            Kind::Storage { element, stride, .. } if element.packed_bytes() != *stride => {
                return Some(stride_problem(binding, element, *stride).at_place(place));
            }
            Kind::Storage { element, .. } => match element.rust() {
                Ok(_) => return None,
                Err(why) => Problem::new(format!("elements of {}: {why}", binding.name)),
            },
            Kind::StorageImage { .. } if declaration.is_some_and(|found| !found.has_format) => {
                Problem::new(format!("storage image {} has no format", binding.name)).way_out(
                    "write [[vk::image_format(\"rgba16f\")]] (or rgba32f, r32f, r32ui, rgba8) before its declaration",
                )
            }
            Kind::StorageImage { format } if format_of(format).is_none() => {
                Problem::new(format!("storage image {} has format {format}", binding.name))
                    .way_out("formats that every tier has are rgba32f, rgba16f, r32f, r32ui and rgba8")
            }
            Kind::Uniform { block, .. } => {
                let bad = block.fields.iter().find_map(|field| field.ty.rust().err().map(|why| (field, why)))?;
                Problem::new(format!("field {} of {}: {}", bad.0.name, binding.name, bad.1))
            }
            _ => return None,
        }
    };
    Some(problem.at_place(place))
}

fn stride_problem(binding: &Binding, element: &Type, stride: u32) -> Problem {
    let unity = element.packed_bytes();
    let what = element.hlsl();
    let way_out = match element {
        Type::Vector(scalar, 3) => format!(
            "use {0}4, or a struct of three {0}s; Unity code that fills it must then use the same stride",
            scalar.hlsl()
        ),
        _ => "fill the gaps with fields of your own until both strides are equal; Unity code that fills it must then use that struct".to_owned(),
    };
    Problem::new(format!(
        "elements of {} ({what}) lie {unity} bytes apart in Unity, but {stride} bytes apart in Vulkan",
        binding.name
    ))
    .way_out(way_out)
}

/// The host's name of a storage image's format.
pub fn format_of(spirv: &str) -> Option<&'static str> {
    Some(match spirv {
        "Rgba32f" => "Rgba32Float",
        "Rgba16f" => "Rgba16Float",
        "R32f" => "R32Float",
        "R32ui" => "R32Uint",
        "Rgba8" => "Rgba8Unorm",
        _ => return None,
    })
}
