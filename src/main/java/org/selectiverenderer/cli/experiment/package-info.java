/**
 * The commands of {@code experiment}: studies, sessions and their results.
 *
 * <p>May use {@code cli.base}, {@code cli.option}, {@code cli.output} and the packages that
 * implement the commands.
 */
@NullMarked
package org.selectiverenderer.cli.experiment;

import org.jspecify.annotations.NullMarked;
