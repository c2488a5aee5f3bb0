@NullMarked
package org.selectiverenderer.apartment.pictures;

import org.jspecify.annotations.NullMarked;
