/**
 * The texts of the window, in English and Greek. Every bundle is a pair of files beside this
 * package in the resources, {@code NAME.properties} and {@code NAME_el.properties}, in UTF-8; a
 * bundle belongs to one part of the window. The language is the system's display language, or the
 * one chosen in the settings ({@code settings}). Names of steps and remarks, which module {@code
 * authoring} makes in English, are translated by the patterns of the bundles {@code steps} and
 * {@code remarks}.
 */
@NullMarked
package org.selectiverenderer.enricher.text;

import org.jspecify.annotations.NullMarked;
