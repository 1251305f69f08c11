# The library and the command for Nix, from the tree that this file lies in: nix-build packaging/nix
{ pkgs ? import <nixpkgs> { } }:

pkgs.callPackage ./package.nix { }
