/**
 * The parts of an installation package beside the program itself: manual pages and shell
 * completions generated from the commands, desktop icons, and the start without a console, which
 * shows failures in a window.
 *
 * <p>In: picocli's model of the commands, the program's icon. Out: files in a folder that {@code
 * packaging/package} lays out. Used by the command line alone.
 */
@NullMarked
package org.selectiverenderer.cli.bundle;

import org.jspecify.annotations.NullMarked;
