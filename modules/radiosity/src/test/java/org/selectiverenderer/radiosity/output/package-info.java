/** Tests of lit scenes as files. */
@NullMarked
package org.selectiverenderer.radiosity.output;

import org.jspecify.annotations.NullMarked;
