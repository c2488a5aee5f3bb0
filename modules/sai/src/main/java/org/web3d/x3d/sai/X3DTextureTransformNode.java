package org.web3d.x3d.sai;

/** A change of texture coordinates (X3D 4.0, clause 18). */
public interface X3DTextureTransformNode extends X3DAppearanceChildNode {}
