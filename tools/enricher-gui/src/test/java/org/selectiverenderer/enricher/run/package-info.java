/** Tests of running the open scene. */
@NullMarked
package org.selectiverenderer.enricher.run;

import org.jspecify.annotations.NullMarked;
