package org.web3d.x3d.sai.rendering;

import org.web3d.x3d.sai.X3DColorNode;

/** Colours of four components, the last the opacity (X3D 4.0, clause 11). */
public interface ColorRGBA extends X3DColorNode {}
