package org.web3d.x3d.sai;

/** Something with a form (X3D 4.0, clause 11). */
public interface X3DGeometryNode extends X3DNode {}
