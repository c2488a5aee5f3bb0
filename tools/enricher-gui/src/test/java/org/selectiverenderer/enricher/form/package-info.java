@NullMarked
package org.selectiverenderer.enricher.form;

import org.jspecify.annotations.NullMarked;
