# Power by the noncentral F distribution for simulated studies, from the exact moments of the scores.
# Shares no code with the program: d' and c are integrated by a fine sum, not by Gauss and Hermite's rule.
# Rscript src/test/scripts/power-golden.R modules/statistics/src/test/resources/org/selectiverenderer/statistics/simulation

out <- commandArgs(TRUE)[1]
rate <- function(count, n, correction) {
  if (correction == "loglinear") (count + 0.5) / (n + 1) else pmin(1 - 0.5 / n, pmax(0.5 / n, count / n))
}
scores <- function(n, measure, correction) {
  z <- qnorm(rate(0:n, n, correction))
  switch(measure,
    d_prime = outer(z, z, function(h, f) h - f),
    log_beta = outer(z, z, function(h, f) (f^2 - h^2) / 2),
    c = outer(z, z, function(h, f) -(h + f) / 2))
}
moments <- function(d, c, sds, typed, present, measure, correction) {
  t <- seq(-7, 7, length.out = 141)
  w <- dnorm(t) / sum(dnorm(t))
  tables <- lapply(present, scores, measure = measure, correction = correction)
  k <- length(present)
  mean <- rep(0, k)
  product <- matrix(0, k, k)
  for (i in seq_along(t)) for (j in seq_along(t)) {
    m <- m2 <- rep(0, k)
    for (l in 1:k) {
      own.d <- d + sds[1] * t[i] + (l == 2) * typed[1]
      own.c <- c + sds[2] * t[j] + (l == 2) * typed[2]
      p <- dbinom(0:present[l], present[l], pnorm(own.d / 2 - own.c))
      q <- dbinom(0:present[l], present[l], pnorm(-own.d / 2 - own.c))
      m[l] <- p %*% tables[[l]] %*% q
      m2[l] <- p %*% tables[[l]]^2 %*% q
    }
    own <- outer(m, m)
    diag(own) <- m2
    mean <- mean + w[i] * w[j] * m
    product <- product + w[i] * w[j] * own
  }
  list(mean = mean, cov = product - outer(mean, mean))
}
power <- function(lambda, df1, df2) 1 - pf(qf(.95, df1, df2), df1, df2, lambda)

rows <- NULL
models <- list(
  list(area = "kitchen", present = c(12, 6), d = c(0.9, 1.2, 1.1), c = c(0, 0, 0), sds = c(.3, .25), typed = c(0, .4)),
  list(area = "kitchen", present = c(12, 6), d = c(0.7, 1.4, 1.0), c = c(0.1, -0.1, 0.3), sds = c(.4, .1), typed = c(-.3, .2)),
  list(area = "desk", present = c(5, 4), d = c(0.5, 1.5), c = c(0, 0.2), sds = c(.5, .3), typed = c(.4, .4)),
  list(area = "office", present = 20, d = c(0.8, 1.1, 1.2), c = c(0, 0.1, 0), sds = c(.3, .25), typed = c(0, 0)))
for (m in models) for (n in c(20, 54)) for (measure in c("d_prime", "log_beta", "c"))
  for (correction in c("loglinear", "half")) {
    g <- length(m$d)
    sizes <- sapply(0:(g - 1), function(i) length(seq(i, n - 1, by = g)))
    cells <- lapply(1:g, function(i) moments(m$d[i], m$c[i], m$sds, m$typed, m$present, measure, correction))
    of <- function(w) {
      y <- sapply(cells, function(x) sum(w * x$mean))
      v <- sum((sizes - 1) * sapply(cells, function(x) drop(w %*% x$cov %*% w))) / (n - g)
      list(y = y, v = v)
    }
    groups <- function(w) {
      x <- of(w)
      power(sum(sizes * (x$y - weighted.mean(x$y, sizes))^2) / x$v, g - 1, n - g)
    }
    two <- length(m$present) > 1
    condition <- groups(if (two) c(.5, .5) else 1)
    type <- interaction <- NA
    if (two) {
      x <- of(c(-1, 1))
      type <- power(mean(x$y)^2 / (x$v * sum(1 / sizes) / g^2), 1, n - g)
      interaction <- groups(c(-1, 1))
    }
    rows <- rbind(rows, data.frame(area = m$area, d = paste(m$d, collapse = " "), c = paste(m$c, collapse = " "),
      d_sd = m$sds[1], c_sd = m$sds[2], type_d = m$typed[1], type_c = m$typed[2], participants = n,
      measure = measure, correction = correction, condition = condition, type = type, interaction = interaction))
  }
options(digits = 12)
write.csv(rows, file.path(out, "power-golden.csv"), row.names = FALSE, na = "", quote = FALSE)
