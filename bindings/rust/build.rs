// SPDX-License-Identifier: Apache-2.0
//! Finds libabut.so: in the folder ABUT_LIB_DIR, or else as pkg-config says.

use std::process::Command;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=ABUT_LIB_DIR");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    println!("cargo:rustc-link-lib=dylib=abut");
    match std::env::var("ABUT_LIB_DIR") {
        Ok(folder) => println!("cargo:rustc-link-search=native={}", folder),
        Err(_) => search_where_pkg_config_says(),
    }
}

fn search_where_pkg_config_says() {
    let answer = Command::new("pkg-config").args(["--libs-only-L", "--keep-system-libs", "abut >= 0.2"]).output();
    let flags = match answer {
        Ok(output) if output.status.success() => String::from_utf8_lossy(&output.stdout).into_owned(),
        _ => panic!(
            "abut was not found. Install it so that `pkg-config abut` finds it (PKG_CONFIG_PATH may name the folder of \
             abut.pc), or set ABUT_LIB_DIR to the folder of libabut.so."
        ),
    };
    for folder in flags.split_whitespace().filter_map(|flag| flag.strip_prefix("-L")) {
        println!("cargo:rustc-link-search=native={}", folder);
    }
}
