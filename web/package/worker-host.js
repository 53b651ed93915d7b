import { createBrindle } from './index.js';
import { serve } from './serve.js';

serve(self, createBrindle);
