package org.web3d.x3d.sai;

/** A node that holds information without being seen, heard or felt (X3D 4.0, clause 7). */
public interface X3DInfoNode extends X3DChildNode {}
