/**
 * Reports in the formats that people and CI systems read: text, JSON, SARIF, JUnit and GitHub's
 * annotations. In: {@link org.selectiverenderer.validation.Report}. Out: characters, the same on
 * every machine. Uses {@code validation} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.validation.report;

import org.jspecify.annotations.NullMarked;
