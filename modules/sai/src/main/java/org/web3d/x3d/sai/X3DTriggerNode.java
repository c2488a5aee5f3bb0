package org.web3d.x3d.sai;

/** A node that turns one kind of event into another (X3D 4.0, clause 30). */
public interface X3DTriggerNode extends X3DChildNode {}
