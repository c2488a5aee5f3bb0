@NullMarked
package org.selectiverenderer.authoring.ratings;

import org.jspecify.annotations.NullMarked;
