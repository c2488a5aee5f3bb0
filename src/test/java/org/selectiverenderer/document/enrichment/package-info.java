@NullMarked
package org.selectiverenderer.document.enrichment;

import org.jspecify.annotations.NullMarked;
