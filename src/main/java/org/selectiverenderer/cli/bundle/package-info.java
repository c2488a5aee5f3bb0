/**
 * What a package of the program has beside the program: manual pages and completions for shells,
 * written from the commands themselves, icons for desktops, and the start without a console, after
 * which a failure is told in a window.
 *
 * <p>In: picocli's model of the commands, the program's icon. Out: files in a folder that {@code
 * packaging/package} lays out. Used by the command line alone.
 */
@NullMarked
package org.selectiverenderer.cli.bundle;

import org.jspecify.annotations.NullMarked;
