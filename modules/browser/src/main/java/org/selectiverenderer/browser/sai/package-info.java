/**
 * The embedded browser behind the Scene Access Interface: SAI objects are proxies onto the nodes
 * and fields of a {@link org.selectiverenderer.browser.World}.
 *
 * <p>A write is done when the call returns, so that the thread reads what it wrote: at once, or
 * when the step that is running on another thread has ended. A listener must therefore not wait for
 * a thread that writes; if it does, the write gives up waiting after a second and is done at the
 * next step. In a bracket of {@code beginUpdate} and {@code endUpdate} the thread's own writes are
 * deferred to its end; reading returns the old value until then. Reads never wait: during a step on
 * another thread they return the current value. Exceptions of listeners are reported as problems
 * and ignored. Events of writes between two frames belong to the next frame, which delivers them.
 *
 * <p>In: calls of {@code org.web3d.x3d.sai}, from any thread. Out: events into the world's cascade,
 * and calls of listeners on the thread that steps the world. One node has one SAI object.
 * Prototypes are expanded while a file is read, so the lists of prototypes are empty; an
 * application sees the interface of an instance ({@code PrototypeInstance}). Uses {@code
 * org.web3d.x3d.sai}, {@code browser} but its renderer, {@code x3d} and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.browser.sai;

import org.jspecify.annotations.NullMarked;
