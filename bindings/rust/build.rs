// SPDX-License-Identifier: Apache-2.0
//! Finds libabut.so, and libabut_picking.so for the feature `picking`: in the folder ABUT_LIB_DIR, or else as pkg-config says.

use std::process::Command;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=ABUT_LIB_DIR");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    println!("cargo:rustc-link-lib=dylib=abut");
    if std::env::var_os("CARGO_FEATURE_PICKING").is_some() {
        println!("cargo:rustc-link-lib=dylib=abut_picking");
    }
    match std::env::var("ABUT_LIB_DIR") {
        Ok(folder) => println!("cargo:rustc-link-search=native={}", folder),
        Err(_) => search_where_pkg_config_says(),
    }
}

fn search_where_pkg_config_says() {
    let asked = Command::new("pkg-config").args(["--libs-only-L", "--keep-system-libs", "abut >= 0.2"]).output();
    let (flags, reason) = match asked {
        Ok(answer) if answer.status.success() => (answer.stdout, None),
        Ok(answer) => (Vec::new(), Some(String::from_utf8_lossy(&answer.stderr).trim().to_owned())),
        Err(failure) => (Vec::new(), Some(format!("pkg-config does not run: {}", failure))),
    };
    if let Some(reason) = reason {
        eprintln!("{}", reason);
        eprintln!("Install abut so that `pkg-config abut` finds it, or set ABUT_LIB_DIR to the folder of libabut.so.");
        std::process::exit(1);
    }
    for folder in String::from_utf8_lossy(&flags).split_whitespace().filter_map(|flag| flag.strip_prefix("-L")) {
        println!("cargo:rustc-link-search=native={}", folder);
    }
}
