/** The command {@code bench}: it reads options, calls this module and prints what came of it. */
@NullMarked
package org.selectiverenderer.bench.command;

import org.jspecify.annotations.NullMarked;
