/** The examples that the program brings. */
@NullMarked
package org.selectiverenderer.app.examples;

import org.jspecify.annotations.NullMarked;
