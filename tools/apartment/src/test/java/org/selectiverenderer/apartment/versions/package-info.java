/** Tests of objects' two versions. */
@NullMarked
package org.selectiverenderer.apartment.versions;

import org.jspecify.annotations.NullMarked;
