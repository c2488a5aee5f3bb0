/** Tests of tables. */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.formats.csv;
