package org.web3d.x3d.sai.grouping;

import org.web3d.x3d.sai.X3DGroupingNode;

/** Children without a transformation (X3D 4.0, clause 10). */
public interface Group extends X3DGroupingNode {}
