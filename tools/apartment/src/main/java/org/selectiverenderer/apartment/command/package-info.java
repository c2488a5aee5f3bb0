/**
 * The command {@code apartment}: it reads options, calls this module and prints what came of it.
 */
@NullMarked
package org.selectiverenderer.apartment.command;

import org.jspecify.annotations.NullMarked;
