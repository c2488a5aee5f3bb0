/**
 * The command {@code radiosity}: it reads options, calls this module and prints what came of it.
 */
@NullMarked
package org.selectiverenderer.radiosity.command;

import org.jspecify.annotations.NullMarked;
