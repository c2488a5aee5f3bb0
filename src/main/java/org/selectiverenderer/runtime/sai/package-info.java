/**
 * The embedded browser behind the Scene Access Interface: SAI objects are proxies onto the nodes
 * and fields of a {@link org.selectiverenderer.runtime.World}.
 *
 * <p>In: calls of {@code org.web3d.x3d.sai}, from any thread. Out: events into the world's cascade.
 * One node has one SAI object. Writes take effect at once, or at the beginning of the next step
 * when a step is under way on another thread. Reads never wait. Prototypes are expanded while a
 * file is read, so the lists of prototypes are empty.
 */
@NullMarked
package org.selectiverenderer.runtime.sai;

import org.jspecify.annotations.NullMarked;
