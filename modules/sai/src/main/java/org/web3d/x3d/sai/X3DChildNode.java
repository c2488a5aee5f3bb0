package org.web3d.x3d.sai;

/** A node that may stand among the children of a grouping node (X3D 4.0, clause 10). */
public interface X3DChildNode extends X3DNode {}
