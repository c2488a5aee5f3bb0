@org.jspecify.annotations.NullMarked
package org.selectiverenderer.study.analysis;
