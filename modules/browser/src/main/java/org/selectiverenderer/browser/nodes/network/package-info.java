/**
 * Sensors of loading from files and the network (X3D 4.0, clause 9): {@link
 * org.selectiverenderer.browser.nodes.network.LoadSensorNode}.
 *
 * <p>In: frames, and notice of files whose reading begins and ends. Out: events. Uses {@code
 * nodes.sensor}, {@code browser.scene}, {@code x3d.catalogue} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.nodes.network;

import org.jspecify.annotations.NullMarked;
