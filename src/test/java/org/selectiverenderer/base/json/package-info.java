/** Tests of JSON that people write and that programs write. */
@NullMarked
package org.selectiverenderer.base.json;

import org.jspecify.annotations.NullMarked;
