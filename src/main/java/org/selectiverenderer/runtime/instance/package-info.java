/**
 * What is where in a running scene: one instance per path from the root to a node, with its world
 * transformation, whether it is shown, its mesh, surface and lights.
 *
 * <p>In: changes of nodes. Out: the {@link org.selectiverenderer.runtime.instance.InstanceTree},
 * kept true at the cost of what changed. Read by the renderer, sensors, navigation and counting. No
 * GL.
 */
@NullMarked
package org.selectiverenderer.runtime.instance;

import org.jspecify.annotations.NullMarked;
