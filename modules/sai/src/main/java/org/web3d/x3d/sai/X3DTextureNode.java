package org.web3d.x3d.sai;

/** An image on a surface (X3D 4.0, clause 18). */
public interface X3DTextureNode extends X3DAppearanceChildNode {}
