@NullMarked
package org.selectiverenderer.apartment.textures;

import org.jspecify.annotations.NullMarked;
