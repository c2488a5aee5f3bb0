/**
 * Head-mounted displays that an OpenXR runtime drives (Khronos, The OpenXR Specification 1.0), and
 * the only door to {@code lwjgl-openxr}, whose classes are loaded when somebody asks for a headset
 * and not before.
 *
 * <p>In: a wish for a posture ({@link org.selectiverenderer.openxr.Posture}), the handles of an
 * OpenGL context ({@link org.selectiverenderer.openxr.GraphicsBinding}), textures that were drawn
 * into. Out, by {@link org.selectiverenderer.openxr.XrHeadset}: when the next frame is due and
 * where head and eyes will be when it is seen ({@link org.selectiverenderer.openxr.XrFrame}), what
 * hands and eyes do ({@link org.selectiverenderer.openxr.XrInput}), and what becomes of headset and
 * runtime, as {@link org.selectiverenderer.openxr.HeadsetNews}.
 *
 * <pre>
 *   XrHeadset (states, loss and return, news)
 *     |-- EyeImages (swapchains)   |-- XrActions, InteractionProfiles (controllers, eyes)
 *     v
 *   XrLoader, XrInstance, XrSession, XrInputs: the functions of OpenXR in plain values
 *     |-- Lwjgl...: the real ones; tests have others
 * </pre>
 *
 * <p>Lengths are metres and angles radians, in the frame of OpenXR, which is that of X3D's viewer:
 * right handed, +Y up, looking along -Z. Times are the runtime's own nanoseconds. A headset belongs
 * to one thread, which has the OpenGL context current; only {@link
 * org.selectiverenderer.openxr.XrHeadset#status} may be read by others. Makes no OpenGL call and
 * knows no scene; uses nothing of the program.
 */
@NullMarked
package org.selectiverenderer.openxr;

import org.jspecify.annotations.NullMarked;
