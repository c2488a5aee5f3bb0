package org.web3d.x3d.sai.rendering;

import org.web3d.x3d.sai.X3DColorNode;

/** Colours of three components (X3D 4.0, clause 11). */
public interface Color extends X3DColorNode {}
