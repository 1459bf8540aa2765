//! The manifest as Android's package manager reads it.

use std::process::Command;

use crate::{built, nothing, output, own};

/// Vulkan 1.0, as the manifest has versions: major << 22.
const VULKAN: u32 = 1 << 22;

/// One of android.properties.
fn property(name: &str) -> String {
    let properties = own("android.properties");
    let value = properties.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix('='));
    value.unwrap_or_else(|| panic!("android.properties has no {name}")).to_owned()
}

/// What is not as it should be in what `aapt2 dump badging` says, and in the tree of the manifest.
fn problems(badging: &str, tree: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    let mut needs = |text: &str, line: &str| {
        if !text.lines().any(|found| found.trim_start().starts_with(line)) {
            wrong.push(format!("no line begins with {line}"));
        }
    };
    needs(badging, &format!("package: name='{}' versionCode=", property("applicationId")));
    needs(badging, &format!("sdkVersion:'{}'", property("minSdk")));
    needs(badging, &format!("targetSdkVersion:'{}'", property("targetSdk")));
    needs(badging, &format!("uses-feature: name='android.hardware.vulkan.version' version='{VULKAN}'"));
    needs(badging, "uses-feature-not-required: name='android.hardware.sensor.accelerometer'");
    needs(badging, "launchable-activity: name='android.app.NativeActivity'");
    needs(badging, "native-code: 'arm64-v8a'");
    // Attributes by their numbers: 1 is portrait, and a library that is not unpacked stays where its pages are.
    needs(tree, &attribute("screenOrientation", 0x0101_001e, "1"));
    needs(tree, &attribute("extractNativeLibs", 0x0101_04ea, "false"));
    needs(tree, &attribute("hasCode", 0x0101_000c, "false"));
    needs(tree, &attribute("exported", 0x0101_0010, "true"));
    needs(tree, &attribute("value", 0x0101_0024, "\"brooklet\""));
    for line in badging.lines().filter(|line| line.contains("permission")) {
        wrong.push(format!("a permission: {line}"));
    }
    for line in badging.lines().filter(|line| line.starts_with("application-debuggable")) {
        wrong.push(format!("debuggable: {line}"));
    }
    wrong
}

fn attribute(name: &str, number: u32, value: &str) -> String {
    format!("A: http://schemas.android.com/apk/res/android:{name}({number:#010x})={value}")
}

#[test]
fn the_manifest_asks_for_vulkan_and_nothing_else() {
    let Some(folder) = built() else { return };
    let package = folder.join("brooklet.apk");
    let aapt2 = |what: &[&str]| output(Command::new("aapt2").arg("dump").args(what).arg(&package)).unwrap();
    let (badging, tree) = (aapt2(&["badging"]), aapt2(&["xmltree", "--file", "AndroidManifest.xml"]));
    println!("{badging}");
    nothing(&problems(&badging, &tree));
    // Each line that is asked for is missed when it is another.
    for (from, to) in [
        ("org.brooklet.app", "org.brooklet.other"),
        ("sdkVersion:'26'", "sdkVersion:'21'"),
        ("targetSdkVersion:'35'", "targetSdkVersion:'29'"),
        ("vulkan.version' version='4194304'", "vulkan.version' version='4198400'"),
        ("android.hardware.vulkan.version", "android.hardware.vulkan.level"),
        ("uses-feature-not-required", "uses-feature"),
        ("NativeActivity", "OtherActivity"),
        ("arm64-v8a", "x86_64"),
        ("launchable-activity", "uses-permission: name='android.permission.INTERNET'\nlaunchable-activity"),
        ("launchable-activity", "application-debuggable\nlaunchable-activity"),
    ] {
        assert!(badging.contains(from), "{from}");
        assert!(!problems(&badging.replace(from, to), &tree).is_empty(), "{to} is taken");
    }
    for (from, to) in [
        ("(0x0101001e)=1", "(0x0101001e)=-1"),
        ("(0x010104ea)=false", "(0x010104ea)=true"),
        ("(0x0101000c)=false", "(0x0101000c)=true"),
        ("(0x01010010)=true", "(0x01010010)=false"),
        ("\"brooklet\"", "\"other\""),
    ] {
        assert!(tree.contains(from), "{from} is not in\n{tree}");
        assert_eq!(problems(&badging, &tree.replace(from, to)).len(), 1, "{to} is taken");
    }
}
