/**
 * The checks: Java, the system, folders to write to; displays, OpenGL and its speed, headsets;
 * serial ports, liblsl, sound, fonts.
 *
 * <p>In: the machine. Out: {@link org.selectiverenderer.doctor.Probe}s, listed by {@link
 * org.selectiverenderer.doctor.probe.ProbeCatalogue}. Libraries are called through the packages
 * that wrap them ({@code render}, {@code openxr}, {@code tracker}, {@code lsl}, {@code
 * browser.sound}). To add one: a class with a method that sends results, and its entry in {@code
 * Probes}.
 */
@NullMarked
package org.selectiverenderer.doctor.probe;

import org.jspecify.annotations.NullMarked;
