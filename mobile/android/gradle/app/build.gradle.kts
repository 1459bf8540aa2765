import java.util.Properties

plugins {
    id("com.android.application") version "8.7.3"
}

// The id and the SDKs stand once, for this project, tools/android and the tests.
val shared = Properties().apply { rootDir.resolve("../android.properties").inputStream().use(::load) }
val repository = rootDir.resolve("../../..")
val workspace = repository.resolve("Cargo.toml").readText()
val released = Regex("(?m)^version = \"(\\d+)\\.(\\d+)\\.(\\d+)\"").find(workspace)!!.destructured.toList()

android {
    namespace = shared.getProperty("applicationId")
    compileSdk = shared.getProperty("targetSdk").toInt()

    defaultConfig {
        applicationId = shared.getProperty("applicationId")
        minSdk = shared.getProperty("minSdk").toInt()
        targetSdk = shared.getProperty("targetSdk").toInt()
        versionName = released.joinToString(".")
        versionCode = released.fold(0) { code, part -> code * 100 + part.toInt() }
        ndk { abiFilters += "arm64-v8a" }
    }

    sourceSets["main"].apply {
        manifest.srcFile("../../AndroidManifest.xml")
        jniLibs.srcDir(repository.resolve("target/android/lib"))
    }

    // Stored as it is, so that Android maps it from the package.
    packaging { jniLibs { useLegacyPackaging = false } }
}

// With the NDK that Android Studio has installed, unless ANDROID_NDK_HOME names another.
val rustLibrary = tasks.register<Exec>("rustLibrary") {
    workingDir = repository
    commandLine("tools/android", "--library")
    if (System.getenv("ANDROID_NDK_HOME") == null) {
        environment("ANDROID_NDK_HOME", android.ndkDirectory.path)
    }
}

tasks.named("preBuild") { dependsOn(rustLibrary) }
