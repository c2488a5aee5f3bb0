package org.web3d.x3d.sai;

/** How a shape looks (X3D 4.0, clause 12). */
public interface X3DAppearanceNode extends X3DNode {}
