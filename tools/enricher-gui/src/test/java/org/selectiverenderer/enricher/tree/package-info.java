/** Tests of the enricher without widgets. */
@NullMarked
package org.selectiverenderer.enricher.tree;

import org.jspecify.annotations.NullMarked;
