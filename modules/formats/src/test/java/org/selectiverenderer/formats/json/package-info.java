/** Tests of JSON that people write and that programs write. */
@NullMarked
package org.selectiverenderer.formats.json;

import org.jspecify.annotations.NullMarked;
