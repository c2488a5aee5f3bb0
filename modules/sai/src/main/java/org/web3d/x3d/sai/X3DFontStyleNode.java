package org.web3d.x3d.sai;

/** How text is set (X3D 4.0, clause 15). */
public interface X3DFontStyleNode extends X3DNode {}
