@NullMarked
package org.selectiverenderer.authoring.enrichment;

import org.jspecify.annotations.NullMarked;
