/**
 * Makes an enriched scene independent of this program: its controller becomes a Script of the
 * scene, with ROUTEs from the ProximitySensors and to the Switches.
 *
 * <p>In: a document of module {@code authoring}. Out: an {@link ExportedScene}, the scene with its
 * files in memory; {@link WebFolder} puts the page of the folder {@code web} around it, so that a
 * web browser shows it. Nothing is written here: the command does. Uses {@code authoring}, {@code
 * schema} and {@code x3d}; no window, no browser.
 */
@NullMarked
package org.selectiverenderer.export;

import org.jspecify.annotations.NullMarked;
