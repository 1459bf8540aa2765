//! HLSL's names in Rust's ways.

/// `countCells`, `CountCells`, `CSMain`, `_Count` to `count_cells`, `count_cells`, `cs_main`, `count`.
pub fn snake(name: &str) -> String {
    let letters: Vec<char> = name.chars().collect();
    let mut snake = String::new();
    for (i, &letter) in letters.iter().enumerate() {
        if !letter.is_ascii_alphanumeric() {
            if !snake.is_empty() && !snake.ends_with('_') {
                snake.push('_');
            }
            continue;
        }
        let after_lower = i > 0 && (letters[i - 1].is_ascii_lowercase() || letters[i - 1].is_ascii_digit());
        let ends_capitals =
            i > 0 && letters[i - 1].is_ascii_uppercase() && letters.get(i + 1).is_some_and(char::is_ascii_lowercase);
        if letter.is_ascii_uppercase() && (after_lower || ends_capitals) && !snake.ends_with('_') && !snake.is_empty() {
            snake.push('_');
        }
        snake.push(letter.to_ascii_lowercase());
    }
    let snake = snake.trim_end_matches('_').to_owned();
    match snake.as_str() {
        "" => "unnamed".to_owned(),
        _ if snake.starts_with(|c: char| c.is_ascii_digit()) => format!("n{snake}"),
        word if KEYWORDS.contains(&word) => format!("{word}_"),
        _ => snake,
    }
}

/// `count_cells`, `CountCells`, `S_CORR`, `CSMain` to `CountCells`, `CountCells`, `SCorr`, `CSMain`.
pub fn pascal(name: &str) -> String {
    let shouted = !name.chars().any(|c| c.is_ascii_lowercase());
    let mut pascal = String::new();
    for word in name.split(|c: char| !c.is_ascii_alphanumeric()) {
        let mut letters = word.chars();
        if let Some(first) = letters.next() {
            pascal.push(first.to_ascii_uppercase());
            let rest: String = letters.collect();
            pascal.push_str(&if shouted { rest.to_ascii_lowercase() } else { rest });
        }
    }
    if pascal.is_empty() || pascal.starts_with(|c: char| c.is_ascii_digit()) {
        pascal.insert(0, 'N');
    }
    pascal
}

const KEYWORDS: [&str; 42] = [
    "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern", "false", "fn",
    "for", "gen", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self",
    "static", "struct", "super", "trait", "true", "type", "unsafe", "use", "variant", "where", "while", "yield", "box",
    "final",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_rust_names() {
        for (hlsl, expected) in [
            ("CountCells", "count_cells"),
            ("countCells", "count_cells"),
            ("CSMain", "cs_main"),
            ("_ParticleCount", "particle_count"),
            ("positions", "positions"),
            ("Grid2D", "grid2_d"),
            ("type", "type_"),
            ("S_CORR", "s_corr"),
        ] {
            assert_eq!(snake(hlsl), expected, "{hlsl}");
        }
        for (hlsl, expected) in
            [("count_cells", "CountCells"), ("S_CORR", "SCorr"), ("CSMain", "CSMain"), ("NARROW_WALLS", "NarrowWalls")]
        {
            assert_eq!(pascal(hlsl), expected, "{hlsl}");
        }
    }
}
