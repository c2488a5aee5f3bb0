/**
 * The dialog in which the author allows a scene to read from further folders and hosts, which the
 * command line calls {@code --allow} and {@code --allow-net}.
 *
 * <p>In: what is allowed so far. Out: what the author allows. Uses {@code enricher.settings},
 * {@code enricher.component}, {@code enricher.text}, {@code x3d.url} and {@code swing}.
 */
@NullMarked
package org.selectiverenderer.enricher.access;

import org.jspecify.annotations.NullMarked;
