//! Surfaces and pictures of the fluid: camera, impostors, frame
