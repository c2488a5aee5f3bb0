package org.web3d.x3d.sai.environmentalsensor;

import org.web3d.x3d.sai.X3DEnvironmentalSensorNode;

/** Senses a box coming into and going out of view (X3D 4.0, clause 22). */
public interface VisibilitySensor extends X3DEnvironmentalSensorNode {}
