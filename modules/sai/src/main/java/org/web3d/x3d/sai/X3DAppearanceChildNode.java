package org.web3d.x3d.sai;

/** A part of an appearance (X3D 4.0, clause 12). */
public interface X3DAppearanceChildNode extends X3DNode {}
