/**
 * What is looked at: Java, the system, places to write; displays, OpenGL and its speed, headsets;
 * serial ports, liblsl, sound, fonts.
 *
 * <p>In: the machine. Out: {@link org.selectiverenderer.doctor.Probe}s, listed by {@link
 * org.selectiverenderer.doctor.probe.Probes}. Libraries are asked through the packages that are
 * their doors ({@code runtime.render}, {@code openxr}, {@code tracker}, {@code lsl}, {@code
 * runtime.sound}). To add one: a class with a method that sends lines, and its entry in {@code
 * Probes}.
 */
@NullMarked
package org.selectiverenderer.doctor.probe;

import org.jspecify.annotations.NullMarked;
