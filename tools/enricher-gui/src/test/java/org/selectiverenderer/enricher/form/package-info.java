/** Tests of the enricher without widgets. */
@NullMarked
package org.selectiverenderer.enricher.form;

import org.jspecify.annotations.NullMarked;
