/** Options and arguments that commands of several modules share. May use {@code x3d}. */
@NullMarked
package org.selectiverenderer.command.option;

import org.jspecify.annotations.NullMarked;
