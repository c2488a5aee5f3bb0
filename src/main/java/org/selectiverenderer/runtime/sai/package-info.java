/**
 * The embedded browser behind the Scene Access Interface: SAI objects are proxies onto the nodes
 * and fields of a {@link org.selectiverenderer.runtime.World}.
 *
 * <p>A write is done when the call returns, so that the thread reads what it wrote: at once, or
 * when the step that is under way on another thread has ended. A listener must therefore not wait
 * for a thread that writes; if it does, the write gives up after a second and is done at the next
 * step. In a bracket of {@code beginUpdate} and {@code endUpdate} the thread's own writes wait for
 * its end; reading gives the old value until then. Reads never wait: during a step elsewhere they
 * give the value of the moment. What listeners throw is reported as a problem and passed over.
 * Events of writes between two frames belong to the next one, which delivers them.
 *
 * <p>In: calls of {@code org.web3d.x3d.sai}, from any thread. Out: events into the world's cascade,
 * and calls of listeners on the thread that steps the world. One node has one SAI object.
 * Prototypes are expanded while a file is read, so the lists of prototypes are empty; of an
 * instance an application sees the interface ({@code InstanceFace}). Uses {@code
 * org.web3d.x3d.sai}, {@code runtime} but its renderer, {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.runtime.sai;

import org.jspecify.annotations.NullMarked;
