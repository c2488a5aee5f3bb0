/**
 * Head-mounted displays of an OpenXR runtime (Khronos, The OpenXR Specification 1.0). Only this
 * package uses {@code lwjgl-openxr}, whose classes are loaded on first use.
 *
 * <p>In: the user's posture ({@link org.selectiverenderer.openxr.Posture}), the handles of an
 * OpenGL context ({@link org.selectiverenderer.openxr.GraphicsBinding}), textures with rendered
 * pictures. Out, by {@link org.selectiverenderer.openxr.XrHeadset}: when the next frame is due,
 * with the predicted poses of head and eyes ({@link org.selectiverenderer.openxr.XrFrame}), the
 * state of controllers and gaze ({@link org.selectiverenderer.openxr.XrInputState}), and changes of
 * the headset's state ({@link org.selectiverenderer.openxr.HeadsetEvent}).
 *
 * <pre>
 *   XrHeadset (states, loss and return, events)
 *     |-- {@code EyeSwapchains} (swapchains)
 *     |-- {@code XrActionBindings}, {@code InteractionProfile} (controllers, eyes)
 *     v
 *   XrLoader, XrInstance, XrSession, {@code XrActionSystem}: interfaces to the functions of OpenXR
 *     |-- Lwjgl...: implementations by LWJGL; tests have fakes
 * </pre>
 *
 * <p>Lengths are metres and angles radians, in the coordinate frame of OpenXR, which is that of
 * X3D's viewer: right handed, +Y up, looking along -Z. Times are the runtime's own nanoseconds. A
 * headset belongs to one thread, which has the OpenGL context current; only {@link
 * org.selectiverenderer.openxr.XrHeadset#status} may be read by others. Makes no OpenGL call, does
 * not depend on the scene, and uses no other package of the program.
 */
@NullMarked
package org.selectiverenderer.openxr;

import org.jspecify.annotations.NullMarked;
