/**
 * Options and parameters that several commands share, as picocli mixins.
 *
 * <p>In: arguments. Out: settings of other packages. Uses {@code command.output}, {@code
 * base.files} for files named in many ways, {@code control} for conditions, {@code tracker} for
 * trackers and {@code x3d.url} for what scenes may name.
 */
@NullMarked
package org.selectiverenderer.cli.option;

import org.jspecify.annotations.NullMarked;
