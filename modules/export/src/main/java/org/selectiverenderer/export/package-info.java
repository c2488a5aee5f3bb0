/**
 * Makes an enriched scene independent of this program: its controller becomes a Script of the
 * scene, with ROUTEs from the ProximitySensors and to the Switches.
 *
 * <p>In: a document of module {@code authoring}. Out: lines of X3D, and copies of scenes. Uses
 * {@code authoring}, {@code schema} and {@code x3d}; no window, no browser.
 */
@NullMarked
package org.selectiverenderer.export;

import org.jspecify.annotations.NullMarked;
