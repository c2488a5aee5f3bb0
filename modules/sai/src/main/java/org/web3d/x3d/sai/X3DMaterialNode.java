package org.web3d.x3d.sai;

/** What a surface is made of (X3D 4.0, clause 12). */
public interface X3DMaterialNode extends X3DAppearanceChildNode {}
